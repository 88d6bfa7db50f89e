# reprise_optimize_shader(<target> SCENARIO file CHOICE file [QUALITY level] [MAX metric=value...] [MAX_ERROR value [METRIC name]]
#                         [OUTPUT directory] [TRAIN NEVER|IF_STALE|ALWAYS] [HEADER file [NAME name]] [BESIDE name])
#
# Makes the package of a committed choice whenever <target> is built and something that the package depends on has changed.
#   QUALITY, MAX, MAX_ERROR, METRIC   what the build allows, as in `reprise optimize`: bound where the build measures, and the step fails
#            where CHOICE was made under a threshold that is higher. Without any of them whatever CHOICE allows will do.
#   OUTPUT   the package's directory; without it reprise/<name of the scenario> in the build folder
#   TRAIN    NEVER (default) needs no device and fails where the choice is stale; IF_STALE then measures and writes CHOICE anew,
#            and also where CHOICE allows too much; ALWAYS measures whenever the package has to be made. Runs that measure wait for
#            each other. Where a run is undecided CHOICE stays as it is.
#   HEADER   the package as a C++ header too, relative to a folder that <target> gets as include directory:
#            reprise_packages::<NAME>, for reprise::readEmbeddedPackage
#   BESIDE   a copy of the package in a folder of this name beside <target>'s executable
function(reprise_optimize_shader target)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "SCENARIO;QUALITY;MAX_ERROR;METRIC;CHOICE;OUTPUT;TRAIN;HEADER;NAME;BESIDE" "MAX")
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "reprise_optimize_shader: unknown words: ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  foreach(needed SCENARIO CHOICE)
    if(NOT DEFINED ARG_${needed})
      message(FATAL_ERROR "reprise_optimize_shader(${target}): ${needed} is missing")
    endif()
  endforeach()
  if(NOT DEFINED ARG_TRAIN)
    set(ARG_TRAIN NEVER)
  endif()
  if(NOT ARG_TRAIN MATCHES "^(NEVER|IF_STALE|ALWAYS)$")
    message(FATAL_ERROR "reprise_optimize_shader(${target}): TRAIN is ${ARG_TRAIN}; it must be NEVER, IF_STALE or ALWAYS")
  endif()
  set(build_step ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/reprise_build_step.cmake)
  cmake_path(ABSOLUTE_PATH ARG_SCENARIO BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
  cmake_path(ABSOLUTE_PATH ARG_CHOICE BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
  cmake_path(GET ARG_SCENARIO STEM scenario_name)
  if(NOT DEFINED ARG_OUTPUT)
    set(ARG_OUTPUT reprise/${scenario_name})
  endif()
  cmake_path(ABSOLUTE_PATH ARG_OUTPUT BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} NORMALIZE)
  set(asked "")
  if(DEFINED ARG_QUALITY)
    list(APPEND asked --quality ${ARG_QUALITY})
  endif()
  foreach(threshold IN LISTS ARG_MAX)
    list(APPEND asked --max ${threshold})
  endforeach()
  if(DEFINED ARG_MAX_ERROR)
    list(APPEND asked --max-error ${ARG_MAX_ERROR})
  endif()
  if(DEFINED ARG_METRIC)
    list(APPEND asked --metric ${ARG_METRIC})
  endif()
  # Makefiles do not see that a command has changed, so that the words are a file, which changes where they do.
  list(JOIN asked " " words)
  file(CONFIGURE OUTPUT ${ARG_OUTPUT}.asked CONTENT "${words}\n" @ONLY)

  # The stamp is the output that is always new; what lies beside it is written only where it differs.
  set(stamp ${ARG_OUTPUT}.stamp)
  set(made ${ARG_OUTPUT}/manifest.json)
  set(header_file "")
  if(DEFINED ARG_HEADER)
    cmake_path(SET include_folder ${CMAKE_CURRENT_BINARY_DIR}/reprise_include)
    set(header_file ${include_folder}/${ARG_HEADER})
    list(APPEND made ${header_file})
    target_include_directories(${target} PRIVATE ${include_folder})
    if(NOT DEFINED ARG_NAME)
      string(MAKE_C_IDENTIFIER ${scenario_name} ARG_NAME)
    endif()
  endif()
  set(beside "")
  if(DEFINED ARG_BESIDE)
    set(beside $<TARGET_FILE_DIR:${target}>/${ARG_BESIDE})
  endif()

  add_custom_command(
    OUTPUT ${stamp} BYPRODUCTS ${made}
    COMMAND ${CMAKE_COMMAND} -DREPRISE=$<TARGET_FILE:Reprise::reprise> -DSCENARIO=${ARG_SCENARIO} "-DASKED=${words}"
            -DCHOICE=${ARG_CHOICE} -DOUTPUT=${ARG_OUTPUT} -DTRAIN=${ARG_TRAIN} -DSTAMP=${stamp}
            "-DHEADER=${header_file}" "-DNAME=${ARG_NAME}" "-DBESIDE=${beside}" -P ${build_step}
    DEPENDS ${ARG_SCENARIO} ${ARG_OUTPUT}.asked ${build_step} $<TARGET_FILE:Reprise::reprise>
    DEPFILE ${ARG_OUTPUT}.d
    COMMENT "Reprise: package of ${scenario_name}"
    VERBATIM)
  target_sources(${target} PRIVATE ${stamp} ${header_file})
endfunction()
