# What is optional is an option: AUTO (on where its packages are found), ON (an error without them) or OFF. AUTO is looked up
# again whenever CMake runs; nothing but what the user has set is kept from one configuration to the next.

# raygauge_option(NAME description default) declares the option. `if(NAME)` is then: look for its packages.
function(raygauge_option name description default)
  set(${name} ${default} CACHE STRING "${description}: AUTO, ON or OFF")
  set_property(CACHE ${name} PROPERTY STRINGS AUTO ON OFF)
  if(NOT "${${name}}" MATCHES "^(AUTO|auto|ON|on|OFF|off|TRUE|true|FALSE|false|YES|yes|NO|no|1|0)$")
    message(FATAL_ERROR "${name} must be AUTO, ON or OFF, not \"${${name}}\"")
  endif()
endfunction()

# raygauge_decide(HAS NAME found what debian-packages) sets HAS, for this folder and those below it, to whether `what` is
# built, and says so in one line; an error where NAME is ON and the packages were not found.
function(raygauge_decide has name found what debian)
  set(_is OFF)
  if(NOT ${name})
    message(STATUS "${what}: off (${name}=${${name}})")
  elseif(found)
    message(STATUS "${what}: on")
    set(_is ON)
  elseif("${${name}}" MATCHES "^(AUTO|auto)$")
    message(STATUS "${what}: off, not found (apt-get install ${debian})")
  else()
    message(FATAL_ERROR "${name}=${${name}} needs what is not found: apt-get install ${debian}; or let ${name} be AUTO")
  endif()
  set(${has} ${_is} CACHE INTERNAL "Whether this is built: ${what}")
endfunction()

# A library, header or program that was found and has been removed since is looked for again.
get_cmake_property(_entries CACHE_VARIABLES)
foreach(_entry IN LISTS _entries)
  get_property(_help CACHE ${_entry} PROPERTY HELPSTRING)
  if(_help MATCHES "^Path to a (file|library|program)" AND IS_ABSOLUTE "${${_entry}}" AND NOT EXISTS "${${_entry}}")
    unset(${_entry} CACHE)
  endif()
endforeach()
