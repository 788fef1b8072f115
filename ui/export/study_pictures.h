// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of studies, drawn by the plots of their pages.
#pragma once

#include "core/report/curve_report.h"
#include "core/report/design_report.h"
#include "core/report/drilling_report.h"
#include "core/report/drilling_scan_report.h"
#include "core/report/gap_report.h"
#include "core/report/identify_report.h"
#include "core/report/map_report.h"
#include "core/study/rows/sweep_rows.h"
#include "ui/export/paper_plots.h"
#include "ui/export/pictures.h"

namespace drillwave {

/// Draw the first view of the page of each study; see renderPictures().
Pictures drawStudy(const CurveReport& report, const PictureOrder& order, const PaperReader& reader = {});
Pictures drawStudy(const DesignReport& report, const PictureOrder& order, const PaperReader& reader = {});
/// The march, or why there is nothing to show.
Pictures drawStudy(const DrillingReport& report, const PictureOrder& order, const PaperReader& reader = {});
/// Requires a parameter along the axis.
Pictures drawStudy(const DrillingScanReport& report, const PictureOrder& order,
                   const PaperReader& reader = {});
Pictures drawStudy(const StudyAnswer& answer, const PictureOrder& order, const PaperReader& reader = {});
/// The main record; requires that it is not refused.
Pictures drawStudy(const IdentifyReport& report, const PictureOrder& order, const PaperReader& reader = {});
Pictures drawStudy(const MapReport& report, const PictureOrder& order, const PaperReader& reader = {});
/// Has no page: the rows as curves, see sweepPanels().
Pictures drawStudy(const SweepRows& rows, const PictureOrder& order, const PaperReader& reader = {});

}  // namespace drillwave
