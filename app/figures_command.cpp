// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave figures -o DIR
#include <algorithm>
#include <cstdio>

#include "app/command.h"
#include "app/interruption.h"
#include "app/output_folder.h"
#include "core/report/figures_page.h"
#include "core/study/paper/figures.h"
#include "ui/export/figure_plot.h"

namespace drillwave {

namespace {

QByteArray drawn(const Figure& figure, const QString& format) {
    QByteArray bytes = drawFigure(figure, format);
    if (bytes.isEmpty())
        throw CommandError(ExitCode::internalError,
                           "Fig. " + std::to_string(figure.number) + " could not be drawn");
    return bytes;
}

/// The page last, so that a folder with a page is complete.
FolderFiles filesOf(const std::vector<Figure>& figures, const std::vector<Discrepancy>& numbers,
                    const Interruption& interruption) {
    FolderFiles folder;
    const auto add = [&](const std::string& name, const std::string& text) {
        folder.files.push_back({QString::fromStdString(name), QByteArray::fromStdString(text)});
    };
    for (const Figure& figure : figures) {
        for (const FigurePanel& panel : figure.panels) add(panel.name + ".csv", panelCsv(panel));
        for (const QString& format : {QStringLiteral("png"), QStringLiteral("svg")})
            folder.files.push_back(
                {QStringLiteral("fig%1.%2").arg(figure.number).arg(format), drawn(figure, format)});
        interruption.check();
    }
    add("discrepancies.csv", discrepanciesCsv(numbers));
    add("index.html", figuresPage(figures, numbers));
    return folder;
}

ExitCode runFigures(const Arguments& arguments) {
    const std::optional<std::string> directory = arguments.value("o");
    if (!directory) throw CommandError(ExitCode::usage, "needs -o DIR, the folder for the figures");
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    const Interruption interruption;
    if (*directory != "-") checkFolder(*directory, {}, overwrite);
    const std::vector<Discrepancy> numbers = discrepancies(interruption.token());
    interruption.check();
    if (*directory == "-") {
        writeFile("-", discrepanciesCsv(numbers), Overwrite::allowed);
        return ExitCode::done;
    }
    const std::vector<Figure> figures = paperFigures(interruption.token());
    interruption.check();
    const FolderFiles folder = filesOf(figures, numbers, interruption);
    writeFolder(*directory, folder, overwrite, interruption);
    const auto agreeing = std::ranges::count_if(numbers, &Discrepancy::agrees);
    std::printf("%zu files in %s; %zu of %zu printed numbers agree, see index.html or discrepancies.csv\n",
                folder.files.size(), directory->c_str(), static_cast<std::size_t>(agreeing), numbers.size());
    return ExitCode::done;
}

}  // namespace

const Command& figuresCommand() {
    static const Command command{
        .name = "figures",
        .operands = "-o DIR",
        .summary = "the figures of the paper, and each number it prints beside the exact one",
        .details =
            "DIR gets the data of Figs 3 to 8 as CSV, the figures as PNG and SVG, discrepancies.csv, and\n"
            "index.html with all of it. Reference curves come with k0 = Z/(2T), as the paper draws them,\n"
            "and with k0 = Z/t0, as it defines it.",
        .options = {{"o", "DIR", "where to write; - prints discrepancies.csv alone"},
                    {"force", "", "overwrite existing files"}},
        .leastOperands = 0,
        .mostOperands = 0,
        .draws = [](const Arguments& arguments) { return arguments.value("o").value_or("-") != "-"; },
        .run = runFigures,
    };
    return command;
}

}  // namespace drillwave
