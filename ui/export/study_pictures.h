// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of studies, drawn by the plots of their pages in the window.
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

/// Returns pictures of a study whose result is curves. They show the first view of its page in the window;
/// see renderPictures().
Pictures drawStudy(const CurveReport& report, const PictureOrder& order, const PaperReader& reader = {});
/// Returns pictures of the designs of a design study. Requires that the study has found a best design
/// (BestDesigns::robust).
Pictures drawStudy(const DesignReport& report, const PictureOrder& order, const PaperReader& reader = {});
/// Returns pictures of many blows in sequence; if there is nothing to show, a picture with the reason.
Pictures drawStudy(const DrillingReport& report, const PictureOrder& order, const PaperReader& reader = {});
/// Returns pictures of a scan: results of many blows over one varied parameter. Requires that this parameter
/// is numerical.
Pictures drawStudy(const DrillingScanReport& report, const PictureOrder& order,
                   const PaperReader& reader = {});
Pictures drawStudy(const StudyAnswer& answer, const PictureOrder& order, const PaperReader& reader = {});
/// Returns pictures of an identification (rock properties from records of strain gauges), drawn for its main
/// record. Requires that this record was not refused.
Pictures drawStudy(const IdentifyReport& report, const PictureOrder& order, const PaperReader& reader = {});
Pictures drawStudy(const MapReport& report, const PictureOrder& order, const PaperReader& reader = {});
/// Returns pictures of a sweep, drawn as curves (see sweepPanels()). A sweep has no page in the window.
Pictures drawStudy(const SweepRows& rows, const PictureOrder& order, const PaperReader& reader = {});

}  // namespace drillwave
