# Finds three.js, which the page of a scene has inside.
#   ThreeJs_FOUND, ThreeJs_FILE: the minified library
find_file(ThreeJs_FILE three.min.js PATHS /usr/share/javascript/three /usr/local/share/javascript/three NO_DEFAULT_PATH)
mark_as_advanced(ThreeJs_FILE)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(ThreeJs REQUIRED_VARS ThreeJs_FILE)
