// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sequences/rowdelegate.h"

#include <QComboBox>
#include <QKeyEvent>
#include <QPointF>

#include "widgets/common/look.h"
#include "widgets/common/numberfield.h"
#include "widgets/sequences/rowsmodel.h"

namespace nmc {

using namespace Qt::StringLiterals;

QWidget* RowDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& /*option*/,
                                   const QModelIndex& index) const {
    const QStringList choices = index.data(RowsModel::ChoicesRole).toStringList();
    if (choices.isEmpty()) {
        const QPointF range = index.data(RowsModel::RangeRole).toPointF();
        auto* field = new NumberField(index.data(RowsModel::DecimalsRole).toInt(), parent);
        look::name(field, u"rowNumberField"_s, tr("Value of the row"));
        field->setRange(range.x(), range.y());
        field->setWords(tr("The value"), {});
        return field;
    }
    auto* box = new QComboBox(parent);
    look::name(box, u"rowChoiceBox"_s, tr("Choices of the row"));
    box->addItems(choices);
    // The list opens at once, so that arrow keys only navigate in it and Enter selects: in a closed box, each
    // arrow key would be an edit. A selection is final; the table needs no further Enter.
    QMetaObject::invokeMethod(box, &QComboBox::showPopup, Qt::QueuedConnection);
    connect(box, &QComboBox::activated, this, [this, box] {
        auto* self = const_cast<RowDelegate*>(this);
        emit self->commitData(box);
        emit self->closeEditor(box);
    });
    return box;
}

void RowDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    const QVariant value = index.data(Qt::EditRole);
    if (auto* box = qobject_cast<QComboBox*>(editor))
        box->setCurrentIndex(value.toInt());
    else if (auto* field = qobject_cast<NumberField*>(editor)) {
        field->showValue(value.toDouble());
        field->selectAll();
    }
}

void RowDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const {
    if (const auto* box = qobject_cast<QComboBox*>(editor))
        model->setData(index, box->currentIndex());
    else if (const auto* field = qobject_cast<NumberField*>(editor))
        if (const auto value = field->value())
            model->setData(index, *value);
}

/// Enter does not close a field without a valid value; the field shows why.
bool RowDelegate::eventFilter(QObject* editor, QEvent* event) {
    if (const auto* field = qobject_cast<NumberField*>(editor);
        field != nullptr && event->type() == QEvent::KeyPress && !field->value()) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter)
            return false;
    }
    return QStyledItemDelegate::eventFilter(editor, event);
}

}  // namespace nmc
