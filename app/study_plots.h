// SPDX-License-Identifier: GPL-3.0-or-later
// Option --plots of a study: its pictures, and their file names beside the file with its numbers.
#pragma once

#include <string>
#include <vector>

#include "app/arguments.h"
#include "app/drawing.h"
#include "app/interruption.h"
#include "app/output_file.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// Returns the picture formats given by --plots, such as "png" and "svg"; empty without the option. Throws
/// CommandError (usage).
std::vector<std::string> plotFormats(const Arguments& arguments);

/// Returns true if --plots is given. Studies use this function as Command::draws.
bool asksForPlots(const Arguments& arguments);

/// Returns the description of the option --plots, which draws pictures of a study.
OptionSpec plotsOptionSpec();

/// Pictures of a study, one in each format of --plots.
class StudyPlots {
  public:
    /// Returns an object for the pictures beside the file of -o, which has the numbers of the study: FILE.png
    /// for FILE.csv. Throws CommandError (usage) if -o is missing, standard output or a device.
    static StudyPlots besideFile(const Arguments& arguments);
    /// Returns an object for the pictures NAME.png (in each format, with NAME = `name`) in the folder of -o,
    /// into which the study writes. Throws CommandError (usage) if -o is missing or standard output.
    static StudyPlots inFolder(const Arguments& arguments, std::string_view name);

    bool areWanted() const { return !m_order.formats.empty(); }
    /// Returns the file names in `files`, followed by those of the pictures, without folder.
    std::vector<std::string> namesWith(std::vector<std::string> files) const;
    /// Checks that the pictures can be written. Call it before any computation. Throws CommandError: usage if
    /// a picture would replace an input; unwritable output if it may not be overwritten.
    void check(const Arguments& arguments, const ScenarioDocument& document, Overwrite overwrite) const;
    /// Returns the pictures of a study's result; none if --plots is not given. Throws CommandError:
    /// unwritable output; interrupted.
    std::vector<NamedFile> draw(const StudyValue& value, const Drawing* drawing,
                                const Interruption& interruption) const;

  private:
    std::vector<std::string> names() const { return namesWith({}); }

    std::string m_folder;  // folder of the pictures, "out/"; empty for the current one
    PictureOrder m_order;
};

/// Writes a study's file together with the pictures of StudyPlots::besideFile(), replacing those of an
/// earlier run. Throws CommandError: unwritable output; interrupted.
void writeStudy(const std::string& path, std::string_view text, std::vector<NamedFile> pictures,
                Overwrite overwrite, const Interruption& interruption);

}  // namespace drillwave
