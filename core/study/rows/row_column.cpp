// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rows/row_column.h"

#include "core/text/handy_text.h"

namespace drillwave {

void RowColumn::appendText(std::string& cell, double number) const {
    switch (kind) {
        case Kind::number:
            appendNumber(cell, number);
            break;
        case Kind::quantity:
            cell += formatQuantity(number, quantity, *unit);
            cell.resize(cell.size() - unit->name.size() - 1);
            break;
        case Kind::word:
            cell += words[static_cast<std::size_t>(number)];
            break;
    }
}

}  // namespace drillwave
