// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/output_words.h"

#include <algorithm>
#include <string>

namespace drillwave {

Message outputMessage(const Output& output) {
    if (output.name == "cor") return translatable("COR e");
    if (output.name == "thrust") return translatable("required feed");
    if (!output.label().empty()) return Message::ofTable(output.label());
    std::string name(output.name);
    std::ranges::replace(name, '_', ' ');
    return Message::ofTable(name);
}

FigureQuantity figureQuantity(const OutputColumn& column, double size) {
    switch (column.output->measure) {
        case Measure::number:
        case Measure::error:
        case Measure::work:
        case Measure::share:
            return PlainNumber::number;
        case Measure::energy:
            return column.quantity() == Quantity::energy ? FigureQuantity(BlowScale::energy)
                                                         : PlainNumber::number;
        case Measure::time:
            return BlowScale::time;
        case Measure::impulse:
            return BlowScale::impulse;
        case Measure::force:
            return BlowScale::force;
        case Measure::penetration:
            return BlowScale::penetration;
        case Measure::stress:
            return BlowScale::stress;
        case Measure::velocity:
            return BlowScale::velocity;
        case Measure::newton:
            return SiValues{Quantity::force, size};
        case Measure::watt:
            return SiValues{Quantity::power, size};
        case Measure::speed:
            return SiValues{Quantity::velocity, size, "rate"};
    }
    return PlainNumber::number;
}

}  // namespace drillwave
