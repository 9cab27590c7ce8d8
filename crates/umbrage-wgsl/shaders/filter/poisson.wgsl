// A fixed table of points on a disc (opengl-tutorial 16).

import package::sampling::disc::umbrage_filter;
import package::sampling::points_fixed::umbrage_point;
