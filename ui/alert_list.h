// What the user should know about a scenario or its solution, in words.
#pragma once

#include <QStringList>
#include <QWidget>
#include <vector>

#include "core/model/validation.h"

namespace drillwave {

class AlertList : public QWidget {
    Q_OBJECT

  public:
    explicit AlertList(QWidget* parent = nullptr);

    /// Shows why there is no solution (when not empty) before the remarks on the scenario.
    void show(const QString& problem, const std::vector<Alert>& alerts);
    /// The texts shown.
    QStringList texts() const { return m_texts; }

  private:
    void add(const QString& mark, const QString& kind, const QString& text);

    QStringList m_texts;
};

}  // namespace drillwave
