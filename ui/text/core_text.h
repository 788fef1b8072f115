// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the core's tables in the language of the window.
#pragma once

#include <QString>
#include <string_view>

#include "core/model/parameter.h"
#include "core/model/section_field.h"
#include "core/text/message.h"

namespace drillwave {

/// A label, meaning or title of a table of the core; what the catalogues do not have stays as it is. Which
/// texts they have: tests/support/core_texts.h.
QString coreText(std::string_view text);

/// "half sine" for the name `half_sine` of a value of an enumeration.
QString coreName(std::string_view name);

/// "stiffness"; of a section "length of hammer section 1", of the law of the rock "force of corner 2".
QString parameterLabel(const Parameter& parameter);

/// Label and symbol, "stiffness k".
QString parameterTitle(const Parameter& parameter);

/// A sentence of the core about parameters with their titles in place of their keys, as the form has them.
Message withTitles(Message message);

}  // namespace drillwave
