// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the rows of a sweep or a table as CSV.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/study/rows/row_sink.h"

namespace drillwave {

/// Callback that writes the next bytes of a file; returns false if it cannot.
using WriteText = std::function<bool(std::string_view)>;

/// Sink that writes header and rows as CSV. A row that was not solved has empty cells for its outputs.
class RowCsv : public RowSink {
  public:
    explicit RowCsv(WriteText write) : m_write(std::move(write)) {}

    bool begin(const RowHeader& header) override;
    void prepare(const RowBlock& rows, std::string& prepared) const override;
    bool take(const RowBlock& rows, std::string_view prepared) override;

  private:
    WriteText m_write;
    std::vector<RowColumn> m_columns;
    bool m_hasCopied = false;
};

}  // namespace drillwave
