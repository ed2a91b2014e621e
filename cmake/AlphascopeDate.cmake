# SPDX-License-Identifier: GPL-3.0-or-later
# ALPHASCOPE_DATE: the date of this version as YEAR-MONTH-DAY, for manual pages and metadata. It is
# that of SOURCE_DATE_EPOCH, else of the newest dated heading in CHANGELOG.md, else of the commit.
# It never depends on the day of the build. Empty: an archive of a version that is not released.
# ALPHASCOPE_RELEASE: "stable", or "development" for a commit between releases.
set(ALPHASCOPE_DATE "")
set(ALPHASCOPE_RELEASE stable)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/CHANGELOG.md)
if(DEFINED ENV{SOURCE_DATE_EPOCH})
  string(TIMESTAMP ALPHASCOPE_DATE "%Y-%m-%d" UTC)  # takes SOURCE_DATE_EPOCH
else()
  file(STRINGS ${PROJECT_SOURCE_DIR}/CHANGELOG.md headings REGEX "^## ${PROJECT_VERSION}[^0-9.].*20[0-9][0-9]-[01][0-9]-[0-3][0-9]")
  if(headings MATCHES "(20[0-9][0-9]-[01][0-9]-[0-3][0-9])")
    set(ALPHASCOPE_DATE ${CMAKE_MATCH_1})
  elseif(EXISTS ${PROJECT_SOURCE_DIR}/.git)
    execute_process(COMMAND git -C ${PROJECT_SOURCE_DIR} log -1 --format=%cs
      OUTPUT_VARIABLE ALPHASCOPE_DATE ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    set(ALPHASCOPE_RELEASE development)
  endif()
endif()
