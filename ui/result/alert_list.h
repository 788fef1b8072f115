// SPDX-License-Identifier: GPL-3.0-or-later
// Alerts about a scenario or its solution, in words.
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

/// Shows alerts one below the other. While they come and go the list keeps the room it once needed, so that
/// what is below stands still until values rest.
class AlertList : public QWidget {
    Q_OBJECT

  public:
    explicit AlertList(QWidget* parent = nullptr);

    /// Shows why there is no solution (when not empty) before the remarks on the scenario.
    void present(const QString& problem, const std::vector<Alert>& alerts, const LocalStyle& style);
    /// The texts shown.
    QStringList texts() const { return m_texts; }
    /// Whether they say why there is no solution.
    bool hasProblem() const { return m_hasProblem; }
    /// How many of them are warnings, and how many mere notes.
    qsizetype warningCount() const { return m_warningCount; }
    qsizetype noteCount() const { return m_texts.size() - m_warningCount - (m_hasProblem ? 1 : 0); }
    /// Gives the keyboard to the first of them.
    void takeFocus();

  signals:
    /// Other texts are shown.
    void changed();
    /// The user follows an alert to its parameter: the key, as in parameters().
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

// How many alerts there are, from where their list may be out of sight.

/// "⚠ 2 alerts": a click leads to the list, the tooltip has its texts.
class AlertLink : public QToolButton {
    Q_OBJECT

  public:
    /// Follows a list that lives as long; hidden while the list is empty.
    explicit AlertLink(const AlertList& list, QWidget* parent = nullptr);

  private:
    void present();

    const AlertList& m_list;
};

}  // namespace drillwave
