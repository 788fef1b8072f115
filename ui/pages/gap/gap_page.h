// SPDX-License-Identifier: GPL-3.0-or-later
// The page COR–gap: what a gap that nobody controls does to a result (paper, Fig. 8).
#pragma once

#include "ui/job/asked_study.h"
#include "ui/pages/gap/gap_picture.h"
#include "ui/pages/gap/gap_study.h"
#include "ui/pages/study/study_page.h"

namespace drillwave {

class ChoiceBox;
class GapPlot;
class ScatterFields;

class GapPage : public StudyPage {
    Q_OBJECT

  public:
    explicit GapPage(Document& document, QWidget* parent = nullptr);

    QString title() const override { return tr("COR–gap"); }
    /// How many studies were started.
    int studies() const { return m_study.started(); }

  protected:
    void ask() override;
    void present() override;
    QByteArray csv() const override;
    QStringList commandWords() const override;

  private:
    struct Shown {
        std::shared_ptr<const GapAnswer> answer;
        GapOutput output = GapOutput::cor;
        ShownUnits units;
        bool operator==(const Shown&) const = default;
    };
    ChoiceBox* outputBox();
    GapOutput output() const;
    Shown wanted() const;
    void draw();
    void placeHere();
    void take(double shownGap);
    QString sentence() const;

    ChoiceBox* m_output;
    ScatterFields* m_scatter;
    GapPlot* m_plot = nullptr;
    Shown m_shown;
    GapPicture m_picture;
    AskedStudy<GapQuestion, GapAnswer> m_study;  // goes first: its thread works
};

}  // namespace drillwave
