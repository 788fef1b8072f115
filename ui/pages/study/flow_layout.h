// SPDX-License-Identifier: GPL-3.0-or-later
// A row of controls that goes on in the next line where the window is narrow.
#pragma once

#include <QLayout>
#include <memory>
#include <vector>

namespace drillwave {

/// Items side by side at their preferred sizes, in as many lines as the width asks for. What is wider than
/// the whole width, such as a row of its own kind, is given that and the height that it needs then.
class FlowLayout : public QLayout {
    Q_OBJECT

  public:
    explicit FlowLayout(QWidget* parent = nullptr);
    ~FlowLayout() override;

    void addItem(QLayoutItem* item) override;
    int count() const override { return static_cast<int>(m_items.size()); }
    QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    Qt::Orientations expandingDirections() const override { return {}; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override { return arrange({0, 0, width, 0}, Moving::no); }
    QSize minimumSize() const override;
    QSize sizeHint() const override;
    void setGeometry(const QRect& area) override;

  private:
    QSize withMargins(const QSize& inside) const;
    enum class Moving { no, yes };
    int arrange(const QRect& area, Moving moving) const;

    std::vector<std::unique_ptr<QLayoutItem>> m_items;
};

}  // namespace drillwave
