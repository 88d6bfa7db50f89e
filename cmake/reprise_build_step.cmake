# One run of the build step (reprise_optimize_shader in RepriseOptimizeShader.cmake):
#   cmake -DREPRISE= -DSCENARIO= -DMAX_ERROR= -DMETRIC= -DCHOICE= -DOUTPUT= -DTRAIN= -DSTAMP= -DHEADER= -DNAME= -DBESIDE= -P this
# The stamp is touched last and removed first, so that a failed run is run again.
file(REMOVE ${STAMP})

set(emit ${REPRISE} emit ${SCENARIO} --choice ${CHOICE} -o ${OUTPUT} -MD -MF ${OUTPUT}.d -MT ${STAMP})
if(HEADER)
  list(APPEND emit --header ${HEADER} --name ${NAME})
endif()

# What optimize measures stays in OUTPUT.training, so that an interrupted run goes on; CHOICE changes only if the choice did.
function(train)
  execute_process(COMMAND ${REPRISE} optimize ${SCENARIO} --max-error ${MAX_ERROR} --metric ${METRIC} -o ${OUTPUT}.training
                  RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "reprise optimize ${SCENARIO} failed (${status})")
  endif()
  execute_process(COMMAND ${CMAKE_COMMAND} -E copy_if_different ${OUTPUT}.training/choice.json ${CHOICE} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "cannot write ${CHOICE}")
  endif()
endfunction()

if(TRAIN STREQUAL "ALWAYS")
  train()
endif()
execute_process(COMMAND ${emit} --error-format json RESULT_VARIABLE status ERROR_VARIABLE errors)
if(NOT status EQUAL 0 AND TRAIN STREQUAL "IF_STALE" AND errors MATCHES "\"code\":\"choice\\.(stale|missing|unsafe)\"")
  message(STATUS "${CHOICE} has to be made anew")
  train()
  execute_process(COMMAND ${emit} RESULT_VARIABLE status)
elseif(NOT status EQUAL 0)
  # Once more for its words.
  execute_process(COMMAND ${emit} RESULT_VARIABLE status)
elseif(errors)
  message("${errors}")
endif()
if(NOT status EQUAL 0)
  message(FATAL_ERROR "no package of ${SCENARIO}")
endif()
if(BESIDE)
  file(GLOB files ${OUTPUT}/*.spv ${OUTPUT}/manifest.json)
  file(MAKE_DIRECTORY ${BESIDE})
  execute_process(COMMAND ${CMAKE_COMMAND} -E copy_if_different ${files} ${BESIDE} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "cannot copy the package to ${BESIDE}")
  endif()
endif()
file(TOUCH ${STAMP})
