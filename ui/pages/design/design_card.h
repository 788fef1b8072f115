// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences of a study of designs, with links that load designs.
#pragma once

#include <QTextBrowser>
#include <optional>

#include "ui/pages/design/design_answer.h"
#include "ui/pages/design/design_units.h"

namespace drillwave {

/// Text that reports the best design, with links that load designs into the scenario.
class DesignCard : public QTextBrowser {
    Q_OBJECT

  public:
    explicit DesignCard(QWidget* parent = nullptr);

    /// Returns the sentence that recommends what to do; the warning of the report if it recommends nothing.
    /// Requires a report with a best design.
    static QString headline(const DesignReport& report, const DesignUnits& units);
    /// Returns the sentences to show after headline(): a warning, if there is one. If the present design is
    /// recommended but another is best, also a sentence that the other is equally good.
    static QStringList besideHeadline(const DesignReport& report, const DesignUnits& units);
    /// Returns the index of the design to change to; nothing if the present design should stay or nothing is
    /// varied.
    static std::optional<std::uint64_t> designToLoad(const DesignReport& report);
    /// Shows an answer. Requires that it has a best design.
    void present(const DesignAnswer& answer, const DesignUnits& units);

    /// Returns the link that loads a design by its index.
    static QUrl linkToDesign(std::uint64_t design);
    /// Returns the link that loads the worst case of an objective by its index.
    static QUrl linkToWorst(std::size_t aim);

  signals:
    /// Reports that the user wants to load the design with this index.
    void designWanted(std::uint64_t design);
    /// Reports that the user wants to load the worst case of the objective with this index.
    void worstWanted(std::size_t aim);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void follow(const QUrl& link);
    void fitHeight();
};

}  // namespace drillwave
