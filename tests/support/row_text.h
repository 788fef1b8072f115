// SPDX-License-Identifier: GPL-3.0-or-later
// Receiver of a study's rows that stores them as CSV text.
#pragma once

#include <string>
#include <string_view>

#include "core/report/row_csv.h"

namespace drillwave::test {

class RowText : public RowCsv {
  public:
    RowText()
        : RowCsv([this](std::string_view text) {
              m_text += text;
              return true;
          }) {}
    const std::string& text() const { return m_text; }

  private:
    std::string m_text;
};

}  // namespace drillwave::test
