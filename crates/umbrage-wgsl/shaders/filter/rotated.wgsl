// A table of points on a disc, at each place turned by another angle.

import package::sampling::disc::umbrage_filter;
import package::sampling::points_rotated::umbrage_point;
