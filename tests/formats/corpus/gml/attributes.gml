# a comment
Creator "somebody"
graph [
  comment "graph [ ] in a string" directed 0
  node [ id 7 label "seven" graphics [ x 0.5 center [ y -1.5e3 ] ] ]
  node [ id -2 ]
  edge [ source 7 target -2 weight 0.5 ]
]
graph [ node [ id 0 ] ]
