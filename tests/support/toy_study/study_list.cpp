// SPDX-License-Identifier: GPL-3.0-or-later
// Linked instead of core/report/study_list.cpp: the list with the toy study.
#include "core/report/gap_report.h"
#include "tests/support/toy_study/toy_study.h"

namespace drillwave {

std::vector<const Study*> studies() {
    return {&gapStudy(), &test::toyStudy()};
}

}  // namespace drillwave
