// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences of a study of designs, with links that load designs.
#pragma once

#include <QTextBrowser>
#include <optional>

#include "ui/pages/design/design_answer.h"
#include "ui/pages/design/design_picture.h"

namespace drillwave {

class DesignCard : public QTextBrowser {
    Q_OBJECT

  public:
    explicit DesignCard(QWidget* parent = nullptr);

    /// Returns what to do, for a report with a best design; of a study without choices its warning.
    static QString headline(const DesignReport& report, const DesignUnits& units);
    /// Returns the sentences that follow the headline: its warning, and the design that is as good as the one
    /// to keep.
    static QStringList besideHeadline(const DesignReport& report, const DesignUnits& units);
    /// The design to change to; nothing where the present one is to stay.
    static std::optional<std::uint64_t> designToLoad(const DesignReport& report);
    /// Shows an answer that has a best design.
    void present(const DesignAnswer& answer, const DesignUnits& units);

    /// Targets of the links.
    static QUrl linkToDesign(std::uint64_t design);
    static QUrl linkToWorst(std::size_t aim);

  signals:
    /// The user wants a design, or the worst case of an aim.
    void designWanted(std::uint64_t design);
    void worstWanted(std::size_t aim);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void follow(const QUrl& link);
    void fitHeight();
};

}  // namespace drillwave
