/// @file
/// The circles of a map to a circle domain. Private to FiltersParameterization/.
#pragma once

#include <vector>

#include "Core/numerics/CircleFit.h"
#include "FieldArrays.h"
#include "Reports/MapReport.h"

class vtkPolyData;

namespace authalic {

/// Field data Circles (x, y, radius per loop) and the member `circles` of the report (the same, one after the other).
inline void addCircles(const std::vector<FittedCircle>& circles, vtkPolyData* map, MapReport& report) {
  Eigen::MatrixXd table(static_cast<Eigen::Index>(circles.size()), 3);
  std::vector<double> numbers;
  for (std::size_t k = 0; k < circles.size(); ++k) {
    table.row(static_cast<Eigen::Index>(k)) << circles[k].centre, circles[k].radius;
    numbers.insert(numbers.end(), {circles[k].centre[0], circles[k].centre[1], circles[k].radius});
  }
  addField(map, "Circles", table);
  report.more.set("circles", Json::arrayOf(numbers));
}

}  // namespace authalic
