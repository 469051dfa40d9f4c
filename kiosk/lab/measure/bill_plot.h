#pragma once

#include "kiosk/exhibit/tuning/scene_bill.h"
#include "kiosk/lab/plots/bill_sheet.h"

namespace onggi::measure {

/// A scene's bill as a sheet to be drawn. Allocates; any thread.
plots::BillSheet sheet_of(const tuning::SceneBill& bill);

}  // namespace onggi::measure
