// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/study_column.h"

#include "core/text/handy_text.h"

namespace drillwave {

std::string shownNumber(double value, NumberStyle style) {
    if (std::isnan(value)) return "-";
    switch (style) {
        case NumberStyle::error:
            return value == 0 ? "0" : numberText(value, std::chars_format::scientific, 1);
        case NumberStyle::time:
            return inHandyUnit(value, Quantity::time, 3);
        case NumberStyle::count:
            return numberText(value, std::chars_format::fixed, 0);
        case NumberStyle::factor:
            if (value >= 1e4) return numberText(value, std::chars_format::scientific, 1);
            return value >= 100 ? numberText(value, std::chars_format::fixed, 0)
                                : numberText(value, std::chars_format::general, 3);
        case NumberStyle::order:
            return numberText(value, std::chars_format::fixed, 2);
    }
    return {};
}

}  // namespace drillwave
