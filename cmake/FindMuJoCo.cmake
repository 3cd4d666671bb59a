# Finds MuJoCo, an engine of physics: MuJoCo_FOUND, target MuJoCo::MuJoCo.
include(RaygaugeFind)
raygauge_find(HEADER mujoco/mujoco.h LIBRARIES mujoco)
