#include "vtkBalanceCurve.h"

#include <cstdint>
#include <utility>
#include <variant>

#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTypeInt64Array.h>

#include "Conversion.h"
#include "Core/authalic/BalanceCurve.h"
#include "Core/base/Error.h"
#include "Core/mesh/SurfaceTopology.h"
#include "MapArrays.h"
#include "Reports/BalanceReport.h"
#include "WholeInputs.h"
#include "vtkSurfaceAlgorithm.h"

vtkStandardNewMacro(vtkBalanceCurve);

namespace {

template <class Array, class Values>
void addColumn(vtkTable* table, const std::string& name, const Values& values) {
  vtkNew<Array> column;
  column->SetName(name.c_str());
  for (const auto& value : values) column->InsertNextValue(value);
  table->AddColumn(column);
}

void fill(vtkTable* table, const authalic::Table& rows) {
  for (const authalic::Table::Column& column : rows.columns()) {
    if (const auto* counts = std::get_if<std::vector<std::int64_t>>(&column.values)) {
      addColumn<vtkTypeInt64Array>(table, column.name, *counts);
    } else if (const auto* numbers = std::get_if<std::vector<double>>(&column.values)) {
      addColumn<vtkDoubleArray>(table, column.name, *numbers);
    } else {
      addColumn<vtkStringArray>(table, column.name, std::get<std::vector<std::string>>(column.values));
    }
  }
}

std::vector<double> equalSteps(int count) {
  std::vector<double> result;
  for (int k = 0; k < count; ++k) result.push_back(double(k) / (count - 1));
  return result;
}

}  // namespace

vtkBalanceCurve::vtkBalanceCurve() {
  this->NumberOfBalances = static_cast<int>(authalic::BalanceCurveOptions().balances.size());
}

void vtkBalanceCurve::AddBalance(double balance) {
  this->Balances.push_back(balance);
  this->Modified();
}

void vtkBalanceCurve::ClearBalances() {
  this->Balances.clear();
  this->Modified();
}

int vtkBalanceCurve::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkBalanceCurve::RequestInformation(vtkInformation* request, vtkInformationVector** inputs,
                                        vtkInformationVector* outputs) {
  authalic::announcePieces(outputs);
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

int vtkBalanceCurve::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*) {
  authalic::requestWholeInputs(this, inputs);
  return 1;
}

int vtkBalanceCurve::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  this->Text.clear();
  this->Report.clear();
  return authalic::runOnWholeInputs(this, inputs, outputs, this->Threads, this->ErrorKind,
                                    [&](vtkInformationVector** whole, const authalic::Execution& execution) {
                                      this->Compute(whole, outputs, execution);
                                    });
}

void vtkBalanceCurve::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                              const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  authalic::BalanceCurveOptions options;
  options.balances = this->Balances.empty() ? equalSteps(this->NumberOfBalances) : this->Balances;
  options.validate();
  const authalic::TriangleMesh mesh = authalic::toTriangleMesh(input);
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, mesh, this->MeasureArrayName);
  const bool closed = authalic::SurfaceTopology(mesh.faces(), mesh.vertexCount()).boundaryLoops().empty();
  const authalic::BalanceCurve curve =
      closed ? authalic::balanceCurve(authalic::SphereMesh(mesh), target, options, execution)
             : authalic::balanceCurve(authalic::DiskMesh(mesh), target, options, execution);
  if (curve.status == authalic::Status::Cancelled) throw authalic::CancelledError();
  this->Publish(vtkTable::GetData(outputs), curve, options);
}

void vtkBalanceCurve::Publish(vtkTable* table, const authalic::BalanceCurve& curve,
                              const authalic::BalanceCurveOptions& options) {
  const authalic::Table rows = authalic::balanceTable(curve);
  fill(table, rows);
  this->Text = rows.tsv();
  authalic::Json used = authalic::Json::object();
  used.set("balances", authalic::Json::arrayOf(options.balances))
      .set("measure", this->MeasureArrayName)
      .set("tolerance", options.tolerance)
      .set("vertex_tolerance", options.vertexTolerance)
      .set("cell_tolerance", options.cellTolerance);
  this->Report = authalic::balanceReport(curve, used).text();
  if (curve.status == authalic::Status::Converged) return;
  this->ErrorKind = vtkSurfaceAlgorithm::NOT_CONVERGED;
  vtkWarningMacro("A map of the curve did not reach its tolerance; the column status says which.");
}

void vtkBalanceCurve::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfBalances: " << this->NumberOfBalances << "\n";
  os << indent << "Balances:";
  for (const double balance : this->Balances) os << " " << balance;
  os << "\n" << indent << "MeasureArrayName: " << this->MeasureArrayName << "\n";
  os << indent << "Threads: " << this->Threads << "\n";
  os << indent << "ErrorKind: " << this->ErrorKind << "\n";
  os << indent << "Text: " << (this->Text.empty() ? "none" : "there is one") << "\n";
  os << indent << "Report: " << (this->Report.empty() ? "none" : "there is one") << "\n";
}
