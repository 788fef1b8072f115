// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures that commands write.
#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/archive/result_files.h"
#include "core/blow/blow.h"
#include "core/disk/whole_folder.h"
#include "core/study/paper/figure_data.h"

namespace drillwave {

struct BlowReport;
struct CurveReport;
struct DesignReport;
struct DrillingReport;
struct DrillingScanReport;
struct IdentifyReport;
struct MapReport;
struct SweepRows;
class StudyAnswer;

/// Result of a study. One that can be drawn has its line here, and its drawStudy() in
/// ui/export/study_pictures.h.
using StudyValue =
    std::variant<const CurveReport*, const DesignReport*, const DrillingReport*, const DrillingScanReport*,
                 const IdentifyReport*, const MapReport*, const StudyAnswer*, const SweepRows*>;

/// Draws in the language of the command, numbers too; its means belong to another program (desktop.h). All
/// functions throw CommandError (unwritable output) if something could not be drawn, and return not all
/// pictures after a stop.
class Drawing {
  public:
    Drawing() = default;
    virtual ~Drawing() = default;
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;

    /// A figure of the paper, in its language, in one of the pictureFormats; empty where it could not be
    /// drawn.
    virtual std::string figure(const Figure& figure, std::string_view format) const = 0;

    /// blow.*, rock.*, wave_picture.* and rod.* of a blow solved with Detail::histories, in each format.
    virtual std::vector<NamedFile> blow(const Blow& blow, const std::vector<std::string>& formats,
                                        const std::stop_token& stop) const = 0;

    /// The report on a blow that was solved, "html" and "pdf".
    virtual std::vector<NamedFile> report(const BlowReport& report, const PictureOrder& order) const = 0;

    /// The picture of a study in each format, as its page in the window shows it at first.
    virtual std::vector<NamedFile> study(const StudyValue& value, const PictureOrder& order) const = 0;
};

}  // namespace drillwave
