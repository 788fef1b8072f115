// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/translation.h"

#include <QCoreApplication>

namespace drillwave {

QString tr(const char* text) {
    return QCoreApplication::translate("drillwave", text);
}

}  // namespace drillwave
