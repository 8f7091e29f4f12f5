#include "Core/imaging/LabelConvention.h"

namespace authalic {

namespace {

void append(std::vector<std::int32_t>& list, std::int32_t first, std::int32_t last, std::int32_t step = 1) {
  for (std::int32_t id = first; id <= last; id += step) list.push_back(id);
}

}  // namespace

LabelConvention LabelConvention::aal() {
  LabelConvention c;
  append(c.left, 1, 89, 2);
  append(c.right, 2, 90, 2);
  append(c.fill, 71, 78);
  append(c.remove, 91, 116);
  return c;
}

LabelConvention LabelConvention::freeSurfer() {
  LabelConvention c;
  c.left = {2, 3, 4, 5, 10, 11, 12, 13, 17, 18, 19, 20, 25, 26, 27, 28, 30, 31, 78, 81};
  c.right = {41, 42, 43, 44, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 62, 63, 79, 82};
  append(c.left, 1000, 1035);
  append(c.right, 2000, 2035);
  append(c.left, 11100, 11175);
  append(c.right, 12100, 12175);
  c.fill = {4,  5,  10, 11, 12, 13, 14, 26, 28, 30, 31, 43, 44, 49,
            50, 51, 52, 58, 60, 62, 63, 77, 78, 79, 80, 81, 82};
  append(c.fill, 250, 255);
  c.remove = {7, 8, 15, 16, 46, 47, 85};
  c.namesBrainstemAndVentricles = true;
  return c;
}

}  // namespace authalic
