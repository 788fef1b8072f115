// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/figures_page.h"

#include <algorithm>

#include "core/model/version.h"
#include "core/report/html_text.h"
#include "core/report/report_text.h"

namespace drillwave {

namespace {

std::string cell(std::string_view text) {
    return htmlElement("td", text);
}

/// A picture that browsers show in a page, the sharper one first, or a link to one that they open.
std::string pictureText(const std::string& number, const std::vector<std::string>& formats) {
    for (const std::string format : {"svg", "png"})
        if (std::ranges::find(formats, format) != formats.end())
            return "<img src=\"fig" + number + "." + format + "\" alt=\"Fig. " + number + "\">";
    return "<a href=\"fig" + number + ".pdf\">fig" + number + ".pdf</a>";
}

std::string figureText(const Figure& figure, const std::vector<std::string>& formats) {
    const std::string number = std::to_string(figure.number);
    std::string text = "<figure>\n" + pictureText(number, formats) + "\n<figcaption>Fig. " + number + ". " +
                       escapedHtml(figure.caption) + " Data:";
    for (const FigurePanel& panel : figure.panels)
        text += " <a href=\"" + panel.name + ".csv\">" + panel.name + ".csv</a>";
    return text + "</figcaption>\n</figure>\n";
}

std::string rowOf(const Discrepancy& number) {
    const char* verdict = number.agrees() ? "agrees" : "differs";
    return std::string("<tr class=\"") + verdict + "\">" + cell(number.place) + cell(number.quantity) +
           cell(number.printed) + cell(rounded(number.computed, 8)) + cell(rounded(number.difference(), 2)) +
           cell(verdict) + cell(number.explanation) + "</tr>\n";
}

constexpr std::string_view pageStyle =
    "body{font-family:sans-serif;max-width:60em;margin:2em auto;padding:0 1em}"
    "table{border-collapse:collapse}td,th{border:1px solid #999;padding:.3em .5em;text-align:left;"
    "vertical-align:top}.differs{background:#fde8d8}figure{margin:2em 0}img{max-width:100%}";

}  // namespace

std::string figuresPage(const std::vector<Figure>& figures, const std::vector<Discrepancy>& numbers,
                        const std::vector<std::string>& formats) {
    const auto agreeing = std::ranges::count_if(numbers, &Discrepancy::agrees);
    std::string page =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<title>The paper and the exact solution</title>\n<style>" +
        std::string(pageStyle) + "</style>\n</head>\n<body>\n<h1>The paper and the exact solution</h1>\n<p>" +
        std::to_string(agreeing) + " of " + std::to_string(numbers.size()) +
        " printed numbers agree to half a unit of their last digit. Written by Drillwave " + versionText +
        ".</p>\n<table>\n<tr><th>place</th><th>quantity</th><th>printed</th><th>computed</th>"
        "<th>difference</th><th></th><th>explanation</th></tr>\n";
    for (const Discrepancy& number : numbers) page += rowOf(number);
    page += "</table>\n";
    for (const Figure& figure : figures) page += figureText(figure, formats);
    return page + "</body>\n</html>\n";
}

}  // namespace drillwave
