// SPDX-License-Identifier: GPL-3.0-or-later
// `--plots` of a study: its pictures, and their places beside its numbers.
#pragma once

#include <string>
#include <vector>

#include "app/arguments.h"
#include "app/drawing.h"
#include "app/interruption.h"
#include "app/output_file.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// The formats of `--plots png,svg`; none without it. Throws CommandError (usage).
std::vector<std::string> plotFormats(const Arguments& arguments);

/// Whether the arguments ask for plots: Command::draws of a study.
bool asksForPlots(const Arguments& arguments);

/// `--plots`, for a table of options.
OptionSpec plotsOptionSpec();

/// The pictures of a study, one in each format.
class StudyPlots {
  public:
    /// Pictures beside the file of -o with the numbers of the study: FILE.png for FILE.csv. Throws
    /// CommandError (usage) where -o is missing, standard output, or a device.
    static StudyPlots besideFile(const Arguments& arguments);
    /// Pictures in the folder of -o, into which the study writes: NAME.png. Throws CommandError (usage) where
    /// -o is missing or standard output.
    static StudyPlots inFolder(const Arguments& arguments, std::string_view name);

    bool areWanted() const { return !m_order.formats.empty(); }
    /// Returns the names of all files in the folder, without it: these files and the pictures.
    std::vector<std::string> namesWith(std::vector<std::string> files) const;
    /// Throws CommandError (unwritable output) where one of them is an input or may not be overwritten:
    /// before anything is computed.
    void check(const Arguments& arguments, const ScenarioDocument& document, Overwrite overwrite) const;
    /// Draws them; none where none are wanted. Throws CommandError: unwritable output; interrupted.
    std::vector<NamedFile> draw(const StudyValue& value, const Drawing* drawing,
                                const Interruption& interruption) const;

  private:
    std::vector<std::string> names() const { return namesWith({}); }

    std::string m_folder;  // "out/", empty for the present one
    PictureOrder m_order;
};

/// Writes a study's file with the pictures of StudyPlots::besideFile(), and replaces an earlier one with the
/// files beside it. Throws CommandError: unwritable output; interrupted.
void writeStudy(const std::string& path, std::string_view text, std::vector<NamedFile> pictures,
                Overwrite overwrite, const Interruption& interruption);

}  // namespace drillwave
