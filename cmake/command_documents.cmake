# SPDX-License-Identifier: Apache-2.0
# Writes the manual pages and completions that the command prints to man/ and completions/ in a folder.
# Usage: cmake -DGLINT=COMMAND -DFOLDER=FOLDER -P cmake/command_documents.cmake
file(MAKE_DIRECTORY ${FOLDER}/man ${FOLDER}/completions)

function(print_to file)
  execute_process(COMMAND ${GLINT} ${ARGN} OUTPUT_FILE ${FOLDER}/${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

print_to(man/glint.1 man)
file(STRINGS ${FOLDER}/man/glint.1 pages REGEX "^\\.BR glint\\\\-[a-z\\-]* \\(1\\)$")
list(TRANSFORM pages REPLACE "^\\.BR glint\\\\-([a-z\\-]*) \\(1\\)$" "\\1")
list(TRANSFORM pages REPLACE "\\\\" "")
foreach(page IN LISTS pages)
  print_to(man/glint-${page}.1 man ${page})
endforeach()
foreach(shell bash zsh fish)
  foreach(program glint glint-povray glint-tachyon)
    print_to(completions/${program}.${shell} completion ${shell} --program ${program})
  endforeach()
endforeach()
