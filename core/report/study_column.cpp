// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/study_column.h"

namespace drillwave {

std::string shownNumber(double value, NumberStyle form, const ReadingStyle& style) {
    if (std::isnan(value)) return style.isPrinted() ? "–" : "-";
    if (style.isPrinted() && (form == NumberStyle::factor || form == NumberStyle::order))
        return style.number(value, 3);
    const auto written = [&](std::chars_format format, int digits) {
        return style.withDecimalSign(numberText(value, format, digits));
    };
    switch (form) {
        case NumberStyle::error:
            return value == 0 ? "0" : style.magnitude(value);
        case NumberStyle::time:
            return style.quantity(value, Quantity::time, 3);
        case NumberStyle::count:
            return written(std::chars_format::fixed, 0);
        case NumberStyle::factor:
            if (value >= 1e4) return written(std::chars_format::scientific, 1);
            return value >= 100 ? written(std::chars_format::fixed, 0)
                                : written(std::chars_format::general, 3);
        case NumberStyle::order:
            return written(std::chars_format::fixed, 2);
    }
    return {};
}

}  // namespace drillwave
