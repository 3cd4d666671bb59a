# Finds Chart.js, which the report's page has inside.
#   ChartJs_FOUND, ChartJs_VERSION, ChartJs_FILE: the minified library
find_file(ChartJs_FILE chart.min.js PATHS /usr/share/javascript/chart.js /usr/local/share/javascript/chart.js
          NO_DEFAULT_PATH)
mark_as_advanced(ChartJs_FILE)
if(ChartJs_FILE)
  file(STRINGS ${ChartJs_FILE} _chart_js_head LIMIT_COUNT 3 REGEX "Chart\\.js v")
  string(REGEX REPLACE ".*Chart\\.js v([0-9.]+).*" "\\1" ChartJs_VERSION "${_chart_js_head}")
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(ChartJs REQUIRED_VARS ChartJs_FILE VERSION_VAR ChartJs_VERSION)
