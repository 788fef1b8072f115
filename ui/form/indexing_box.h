// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the bit meets new rock with every blow: a word, and so no row of numbers.
#pragma once

#include <QGridLayout>

#include "ui/document/document.h"

namespace drillwave {

class ChoiceBox;

/// A row of its own in the grid of a section.
class IndexingBox : public QObject {
    Q_OBJECT

  public:
    /// Fills the lowest row of `grid`. The document must outlive it.
    IndexingBox(Document& document, QGridLayout* grid, QWidget* parent);

    void present(const Scenario& scenario);

  private:
    void choose(RockIndexing indexing);

    Document& m_document;
    ChoiceBox* m_box;
};

}  // namespace drillwave
