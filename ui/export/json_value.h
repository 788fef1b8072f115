// SPDX-License-Identifier: GPL-3.0-or-later
// Values of JSON reports.
#pragma once

#include <QJsonObject>
#include <QJsonValue>
#include <QString>
#include <cmath>
#include <string_view>

#include "core/model/scenario.h"
#include "core/text/units.h"
#include "ui/text/shown_text.h"

namespace drillwave {

inline QString jsonText(std::string_view text) {
    return fromView(text);
}

/// null where there is no number.
inline QJsonValue jsonNumber(double value) {
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue(QJsonValue::Null);
}

/// The SI unit of a quantity; "1" for a ratio.
inline QJsonValue unitJson(Quantity quantity) {
    const std::string_view unit = unitsOf(quantity).front().name;
    return jsonText(unit.empty() ? "1" : unit);
}

inline QJsonObject groupsJson(const Groups& groups) {
    return {{"beta", groups.beta}, {"gamma", groups.gamma}, {"tau", groups.tau}, {"delta", groups.delta}};
}

}  // namespace drillwave
