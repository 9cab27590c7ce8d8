// A spiral of equal areas (Vogel 1979), at each place turned by another angle.

import package::sampling::disc::umbrage_filter;
import package::sampling::points_rotated::umbrage_point;
