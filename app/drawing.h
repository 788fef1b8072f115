// SPDX-License-Identifier: GPL-3.0-or-later
// Interface by which commands draw pictures without depending on Qt.
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

/// Pointer to the result of a study that can be drawn. Each type listed here has a drawStudy() in
/// ui/export/study_pictures.h.
using StudyValue =
    std::variant<const CurveReport*, const DesignReport*, const DrillingReport*, const DrillingScanReport*,
                 const IdentifyReport*, const MapReport*, const StudyAnswer*, const SweepRows*>;

/// Interface for drawing pictures with words and numbers in the language of the command. The implementation
/// may be in another program, see desktop.h. All functions throw CommandError (unwritable output) if drawing
/// fails. After a stop request they return only the pictures drawn so far.
class Drawing {
  public:
    Drawing() = default;
    virtual ~Drawing() = default;
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;

    /// Returns a figure of the paper as the bytes of a file in one of the pictureFormats; empty if it could
    /// not be drawn. Its words are English, as in the paper.
    virtual std::string figure(const Figure& figure, std::string_view format) const = 0;

    /// Returns the pictures of one blow in each format: blow.*, rock.*, wave_picture.* and rod.*. Requires a
    /// blow solved with Detail::histories.
    virtual std::vector<NamedFile> blow(const Blow& blow, const std::vector<std::string>& formats,
                                        const std::stop_token& stop) const = 0;

    /// Returns the files of the report on a solved blow, one for each format in `order` ("html" or "pdf").
    virtual std::vector<NamedFile> report(const BlowReport& report, const PictureOrder& order) const = 0;

    /// Returns the picture of a study in each format in `order`. It shows the first view of the study's page
    /// in the window.
    virtual std::vector<NamedFile> study(const StudyValue& value, const PictureOrder& order) const = 0;
};

}  // namespace drillwave
