// SPDX-License-Identifier: GPL-3.0-or-later
// What the form says of a drill string beside its numbers: how much of it there is, where its sections are
// edited, and whether the hammer strikes again.
#pragma once

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QObject>
#include <QPushButton>

#include "ui/document/document.h"

namespace drillwave {

/// Its widgets live in the grids of two sections of the form.
class StringSection : public QObject {
    Q_OBJECT

  public:
    /// Fills the next rows of `grid`. The document must outlive it.
    StringSection(Document& document, QGridLayout* grid, QWidget* parent);

    /// Below the rows of the hammer.
    void addRestrike(QGridLayout* grid, QWidget* parent);
    /// Requires a drill string.
    void present(const Scenario& scenario);

  signals:
    void sectionsRequested();

  private:
    void setRestrike(bool restrike);

    Document& m_document;
    QLabel* m_summary;
    QCheckBox* m_restrike = nullptr;
};

}  // namespace drillwave
