// SPDX-License-Identifier: GPL-3.0-or-later
// What the tip of a field says of its parameter.
#pragma once

#include <QString>

#include "core/model/parameter.h"

namespace drillwave {

/// The same twice: for a tooltip, and for a screen reader.
struct ParameterTip {
    QString html;
    QString plain;
};

/// Meaning, range and what is usual, in that unit, and that F1 tells more.
ParameterTip tipOf(const Parameter& parameter, const Unit& shown);

}  // namespace drillwave
