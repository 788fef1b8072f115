// SPDX-License-Identifier: GPL-3.0-or-later
// A list of the alerts about a scenario or its solution, in words.
#pragma once

#include <QLabel>
#include <QStringList>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <string_view>
#include <vector>

#include "core/model/alerts.h"
#include "core/model/validation.h"
#include "ui/text/language.h"

namespace drillwave {

/// List of alerts, one below the other. When it becomes shorter, it keeps its height for a moment, so that
/// widgets below do not move while values are dragged.
class AlertList : public QWidget {
    Q_OBJECT

  public:
    explicit AlertList(QWidget* parent = nullptr);

    /// Shows the alerts about the scenario. If `problem`, the reason for a missing solution, is not empty, it
    /// comes first.
    void present(const QString& problem, const std::vector<Alert>& alerts, const LocalStyle& style);
    /// Returns the texts of the list: first the reason for a missing solution, if there is one, then one text
    /// for each alert.
    QStringList texts() const { return m_texts; }
    /// Returns whether the first text of the list is the reason for a missing solution, not an alert.
    bool hasProblem() const { return m_hasProblem; }
    /// Returns the number of warnings in the list.
    qsizetype warningCount() const { return m_warningCount; }
    /// Returns the number of notes in the list, which are neither warnings nor the reason for a missing
    /// solution.
    qsizetype noteCount() const { return m_texts.size() - m_warningCount - (m_hasProblem ? 1 : 0); }
    /// Gives the keyboard focus to the first alert.
    void takeFocus();

  signals:
    /// Reports that the texts have changed.
    void changed();
    /// Reports that the user has clicked the name of a parameter in an alert. `key` is the parameter's key in
    /// scenario files, as listed by parameters().
    void parameterChosen(const QString& key);

  private:
    void write(qsizetype row, const QString& mark, const QString& kind, const QString& text,
               const Alert* alert = nullptr);
    QLabel* labelAt(qsizetype row);

    QStringList m_texts;
    bool m_hasProblem = false;
    qsizetype m_warningCount = 0;
    QList<QLabel*> m_labels;
    QTimer m_rest;
};

// A button that shows the number of alerts, for places where the list may be out of sight.

/// Button with the number of alerts, such as "⚠ 2 warnings · ℹ 1 note"; its tooltip lists them. It is placed
/// where the list itself may be out of sight.
class AlertLink : public QToolButton {
    Q_OBJECT

  public:
    /// Creates a button for a list, which must outlive it. The button is hidden while the list is empty.
    explicit AlertLink(const AlertList& list, QWidget* parent = nullptr);

  private:
    void present();

    const AlertList& m_list;
};

}  // namespace drillwave
