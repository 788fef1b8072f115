// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/study_plots.h"

#include "app/command_error.h"
#include "app/scenario_argument.h"

namespace drillwave {

namespace {

/// Returns the place given by -o; throws if pictures cannot be there.
std::string placeOf(const Arguments& arguments, const char* what) {
    const std::string place = arguments.value("o").value_or("-");
    if (place == "-")
        throw CommandError(ExitCode::usage, Message(translatable("%1 applies to files; add -o %2"),
                                                    {std::string("--plots"), std::string(what)}));
    return place;
}

/// "out/" of "out/map.csv", empty of "map.csv".
std::string prefixOf(const std::string& path) {
    return path.substr(0, path.rfind('/') + 1);
}

}  // namespace

std::vector<std::string> plotFormats(const Arguments& arguments) {
    return arguments.listed("plots", pictureFormats,
                            translatable("--plots %1: `%2` is not a plot format; choose from %3"));
}

bool asksForPlots(const Arguments& arguments) {
    return arguments.has("plots");
}

OptionSpec plotsOptionSpec() {
    return {"plots", "png,svg,pdf",
            "with -o, also write the plots that the window would show, as png, svg or pdf"};
}

StudyPlots StudyPlots::besideFile(const Arguments& arguments) {
    StudyPlots plots;
    plots.m_order.formats = plotFormats(arguments);
    if (!plots.areWanted()) return plots;
    const std::string path = placeOf(arguments, "FILE.csv");
    if (isStream(path))
        throw CommandError(
            ExitCode::usage,
            Message(translatable("--plots needs a file to store pictures beside, not %1; give -o FILE.csv"),
                    {path}));
    plots.m_folder = prefixOf(path);
    plots.m_order.stem = studyStem(path.substr(plots.m_folder.size()));
    plots.m_order.mark = studyPictureMark;
    return plots;
}

StudyPlots StudyPlots::inFolder(const Arguments& arguments, std::string_view name) {
    StudyPlots plots;
    plots.m_order.formats = plotFormats(arguments);
    if (!plots.areWanted()) return plots;
    plots.m_folder = placeOf(arguments, "DIR") + "/";
    plots.m_order.stem = name;
    plots.m_order.mark = studyPictureMark;
    return plots;
}

std::vector<std::string> StudyPlots::namesWith(std::vector<std::string> files) const {
    for (const std::string& format : m_order.formats) files.push_back(m_order.stem + "." + format);
    return files;
}

void StudyPlots::check(const Arguments& arguments, const ScenarioDocument& document,
                       Overwrite overwrite) const {
    for (const std::string& name : names()) {
        checkOutputIsNoInput(m_folder + name, arguments, document);
        checkOverwrite(m_folder + name, overwrite);
    }
}

std::vector<NamedFile> StudyPlots::draw(const StudyValue& value, const Drawing* drawing,
                                        const Interruption& interruption) const {
    if (!areWanted()) return {};
    PictureOrder order = m_order;
    order.stop = interruption.token();
    std::vector<NamedFile> pictures = drawing->study(value, order);
    interruption.check();
    return pictures;
}

void writeStudy(const std::string& path, std::string_view text, std::vector<NamedFile> pictures,
                Overwrite overwrite, const Interruption& interruption) {
    OutputFile file(path, overwrite);
    file.write(text);
    for (NamedFile& picture : pictures) file.add(std::move(picture));
    file.commit(&interruption);
}

}  // namespace drillwave
