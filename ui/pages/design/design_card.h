// SPDX-License-Identifier: GPL-3.0-or-later
// What a study of designs says, in sentences to act on, with buttons beside them.
#pragma once

#include <QWidget>
#include <vector>

#include "ui/pages/design/design_answer.h"
#include "ui/pages/design/design_picture.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace drillwave {

class DesignCard : public QWidget {
    Q_OBJECT

  public:
    explicit DesignCard(QWidget* parent = nullptr);

    /// Of an answer that has a best design.
    void present(const DesignAnswer& answer, const DesignUnits& units);
    void clear();
    /// All sentences, for assistive tools and tests.
    QString text() const;

  signals:
    /// The user wants a design, or the worst case of an aim.
    void designWanted(std::uint64_t design);
    void worstWanted(std::size_t aim);

  private:
    QLabel* addLabel(const char* name);

    QVBoxLayout* m_layout;
    QLabel *m_best, *m_measure, *m_state, *m_remarks;
    QPushButton *m_loadBest, *m_loadNominal;
    struct Worst {
        QLabel* label;
        QPushButton* load;
    };
    std::vector<Worst> m_worst;
    std::uint64_t m_robust = 0, m_nominal = 0;
};

}  // namespace drillwave
