// SPDX-License-Identifier: GPL-3.0-or-later
// The levels of which a map has contours, in a line to type them.
#pragma once

#include <QLineEdit>
#include <vector>

namespace drillwave {

/// "1; 1.2" in the numbers of the user. Text that is no list of numbers stays, marked with the reason, and
/// changes nothing.
class LevelField : public QLineEdit {
    Q_OBJECT

  public:
    /// Maximum number of levels, so that contours can be distinguished.
    static constexpr std::size_t mostLevels = 12;

    explicit LevelField(QWidget* parent = nullptr);

    /// The levels in shown units; none for no contours.
    const std::vector<double>& levels() const { return m_levels; }
    /// Shows other levels, without a signal.
    void setLevels(const std::vector<double>& levels);
    /// Why the text is no list of levels; empty when it is.
    const QString& problem() const { return m_problem; }

  signals:
    /// levels() are others.
    void changed();

  private:
    void read();
    void presentProblem();

    std::vector<double> m_levels;
    QString m_problem;
};

}  // namespace drillwave
