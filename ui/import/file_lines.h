// SPDX-License-Identifier: GPL-3.0-or-later
// The first lines of a file that is imported, with their numbers.
#pragma once

#include <QPlainTextEdit>
#include <string>
#include <vector>

namespace drillwave {

/// To be read only; a few lines high.
class FileLines : public QPlainTextEdit {
    Q_OBJECT

  public:
    explicit FileLines(QWidget* parent = nullptr);

    /// Goes to the first sample, whose line counts from 1, and marks it.
    void present(const std::vector<std::string>& lines, std::size_t firstSample);
};

}  // namespace drillwave
