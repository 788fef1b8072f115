// SPDX-License-Identifier: GPL-3.0-or-later
// Words for people in functions that belong to no QObject.
#pragma once

#include <QString>

namespace drillwave {

/// In the language of the program, under the context `drillwave`: what QObject::tr() is for classes.
QString tr(const char* text);

}  // namespace drillwave
