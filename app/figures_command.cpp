// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave figures -o DIR
#include <algorithm>
#include <cstdio>
#include <iterator>

#include "app/command.h"
#include "app/interruption.h"
#include "app/output_file.h"
#include "app/output_folder.h"
#include "app/study_plots.h"
#include "core/archive/result_files.h"
#include "core/report/figures_page.h"
#include "core/study/paper/figures.h"

namespace drillwave {

namespace {

std::string drawn(const Drawing& drawing, const Figure& figure, std::string_view format) {
    std::string bytes = drawing.figure(figure, format);
    if (bytes.empty())
        throw CommandError(ExitCode::internalError, Message(translatable("Fig. %1 could not be drawn"),
                                                            {std::to_string(figure.number)}));
    return bytes;
}

/// Returns the formats of --plots; PNG and SVG without it.
std::vector<std::string> formatsOf(const Arguments& arguments) {
    if (arguments.has("plots") && arguments.value("o").value_or("-") == "-")
        throw CommandError(ExitCode::usage, Message(translatable("%1 applies to files; add -o %2"),
                                                    {std::string("--plots"), std::string("DIR")}));
    std::vector<std::string> formats = plotFormats(arguments);
    return formats.empty() ? std::vector<std::string>{"png", "svg"} : formats;
}

constexpr char pageName[] = "index.html", numbersName[] = "discrepancies.csv";

std::string stemOf(const Figure& figure) {
    return "fig" + std::to_string(figure.number);
}

/// Pictures of an earlier run, which may have had other formats.
std::vector<std::string> figuresThere(const std::string& folder, const std::vector<Figure>& figures) {
    std::vector<std::string> names;
    for (const Figure& figure : figures)
        std::ranges::copy(picturesThere(folder, stemOf(figure), figureMark), std::back_inserter(names));
    return names;
}

/// The page last, so that a folder with a page is complete.
FolderFiles filesOf(const std::vector<Figure>& figures, const std::vector<Discrepancy>& numbers,
                    const std::vector<std::string>& formats, const Drawing& drawing,
                    const Interruption& interruption) {
    FolderFiles folder;
    for (const Figure& figure : figures) {
        for (const FigurePanel& panel : figure.panels)
            folder.files.push_back({panel.name + ".csv", panelCsv(panel)});
        for (const std::string& format : formats)
            folder.files.push_back({stemOf(figure) + "." + format, drawn(drawing, figure, format)});
        interruption.check();
    }
    folder.files.push_back({numbersName, discrepanciesCsv(numbers)});
    folder.files.push_back({pageName, figuresPage(figures, numbers, formats)});
    folder.outdated = [&figures](const std::string& there) { return figuresThere(there, figures); };
    return folder;
}

ExitCode runFigures(const Arguments& arguments, const Drawing* drawing) {
    const std::optional<std::string> directory = arguments.value("o");
    if (!directory)
        throw CommandError(ExitCode::usage, translatable("needs -o DIR, the folder for the figures"));
    const std::vector<std::string> formats = formatsOf(arguments);
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    const Interruption interruption;
    if (*directory != "-") checkFolder(*directory, {numbersName, pageName}, overwrite);
    const std::vector<Discrepancy> numbers = discrepancies(interruption.token());
    interruption.check();
    if (*directory == "-") {
        printText(inCsvSigns(discrepanciesCsv(numbers)));
        return ExitCode::done;
    }
    const std::vector<Figure> figures = paperFigures(interruption.token());
    interruption.check();
    const FolderFiles folder = filesOf(figures, numbers, formats, *drawing, interruption);
    writeFolder(*directory, folder, overwrite, &interruption);
    const auto agreeing = std::ranges::count_if(numbers, &Discrepancy::agrees);
    const Message done{translatable("%1 files in %2; %3 of %4 printed numbers agree, see index.html or "
                                    "discrepancies.csv"),
                       {std::to_string(folder.files.size()), *directory, std::to_string(agreeing),
                        std::to_string(numbers.size())}};
    std::printf("%s\n", arguments.style().said(done).c_str());
    return ExitCode::done;
}

}  // namespace

const Command& figuresCommand() {
    static const Command command{
        .name = "figures",
        .operands = "-o DIR",
        .summary =
            "reproduce the figures of the paper on which the model is based; compare each number printed "
            "there with the exact one",
        .details =
            "Writes into DIR the data of Figs 3 to 8 of the paper on which the model is based, as CSV "
            "and\nas pictures. discrepancies.csv compares each number printed in that paper with the exact "
            "one.\nindex.html shows all of them. The reference curves are written twice, because the "
            "paper\nscales stiffness in two ways: by k0 = Z/(2T) in its plots, by k0 = Z/t0 in its text. Z "
            "is the\nimpedance of the rod, T the time that a wave takes along the rod, t0 the duration of "
            "the\nblow.",
        .options = {{"o", "DIR",
                     "folder to write into; -o - prints only discrepancies.csv (printed and exact numbers of "
                     "the paper)"},
                    {"plots", "png,svg,pdf", "formats of the figures (default: png,svg)"},
                    {"force", "", "overwrite existing files"},
                    decimalCommaSpec()},
        .leastOperands = 0,
        .mostOperands = 0,
        .draws = [](const Arguments& arguments) { return arguments.value("o").value_or("-") != "-"; },
        .run = runFigures,
    };
    return command;
}

}  // namespace drillwave
