// SPDX-License-Identifier: GPL-3.0-or-later
// Field for typing the values at which a map has contours.
#pragma once

#include <QLineEdit>
#include <vector>

namespace drillwave {

/// Field for the values at which a map has contours, such as "1; 1.2", in the number format of the user.
/// Invalid text stays, is marked with its reason, and changes nothing.
class LevelField : public QLineEdit {
    Q_OBJECT

  public:
    /// Largest number of contours, so that they can be distinguished.
    static constexpr std::size_t mostLevels = 12;

    explicit LevelField(QWidget* parent = nullptr);

    /// Returns the values of the contours, in the units shown; empty for no contours.
    const std::vector<double>& levels() const { return m_levels; }
    /// Shows the values at which a map has contours, in the units shown. Emits no signal.
    void setLevels(const std::vector<double>& levels);
    /// Returns why the text is not a list of numbers; empty if it is one.
    const QString& problem() const { return m_problem; }

  signals:
    /// Reports that levels() has changed.
    void changed();

  private:
    void read();
    void presentProblem();

    std::vector<double> m_levels;
    QString m_problem;
};

}  // namespace drillwave
