// Points picked at random from a table, at each place others (opengl-tutorial 16).

import package::sampling::disc::umbrage_filter;
import package::sampling::points_stratified::umbrage_point;
