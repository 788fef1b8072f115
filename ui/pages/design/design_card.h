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

    /// Returns the sentence that recommends a design. If the report recommends none, returns its warning.
    /// Requires a report with a best design.
    static QString headline(const DesignReport& report, const DesignUnits& units);
    /// Returns the sentences to show after headline(): a warning, if there is one. If the report recommends
    /// the present design although another is best, also a sentence that the other is equally good.
    static QStringList besideHeadline(const DesignReport& report, const DesignUnits& units);
    /// Returns the index of the recommended design. Empty if the user should keep the present design, if no
    /// design is clearly better, or if the study varies nothing.
    static std::optional<std::uint64_t> designToLoad(const DesignReport& report);
    /// Shows the sentences and links for the answer of a design study. Requires that it has a best design.
    void present(const DesignAnswer& answer, const DesignUnits& units);

    /// Returns the link that loads a design by its index.
    static QUrl linkToDesign(std::uint64_t design);
    /// Returns the link that loads the worst case of an objective: the best design with the uncertain inputs
    /// that are worst for it. `aim` is the index of the objective.
    static QUrl linkToWorst(std::size_t aim);

  signals:
    /// Reports that the user wants to load the design with this index.
    void designWanted(std::uint64_t design);
    /// Reports that the user wants to load the worst case of an objective: the inputs that are worst for the
    /// best design. `aim` is the index of the objective.
    void worstWanted(std::size_t aim);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void follow(const QUrl& link);
    void fitHeight();
};

}  // namespace drillwave
