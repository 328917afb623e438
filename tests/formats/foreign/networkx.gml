graph [
  name "Petersen"
  node [
    id 0
    label "0"
    x 0.0
    good 1
  ]
  node [
    id 1
    label "1"
    x 0.3333333333333333
    good 0
  ]
  node [
    id 2
    label "2"
    x 0.6666666666666666
    good 1
  ]
  node [
    id 3
    label "3"
    x 1.0
    good 0
  ]
  node [
    id 4
    label "4"
    x 1.3333333333333333
    good 1
  ]
  node [
    id 5
    label "5"
    x 1.6666666666666667
    good 0
  ]
  node [
    id 6
    label "6"
    x 2.0
    good 1
  ]
  node [
    id 7
    label "7"
    x 2.3333333333333335
    good 0
  ]
  node [
    id 8
    label "8"
    x 2.6666666666666665
    good 1
  ]
  node [
    id 9
    label "9"
    x 3.0
    good 0
  ]
  edge [
    source 0
    target 1
    weight 0.5
    colour "blue"
  ]
  edge [
    source 0
    target 4
    weight 1.5
    colour "blue"
  ]
  edge [
    source 0
    target 5
    weight 2.5
    colour "blue"
  ]
  edge [
    source 1
    target 2
    weight 3.5
    colour "blue"
  ]
  edge [
    source 1
    target 6
    weight 4.5
    colour "blue"
  ]
  edge [
    source 2
    target 3
    weight 5.5
    colour "blue"
  ]
  edge [
    source 2
    target 7
    weight 6.5
    colour "blue"
  ]
  edge [
    source 3
    target 4
    weight 7.5
    colour "blue"
  ]
  edge [
    source 3
    target 8
    weight 8.5
    colour "blue"
  ]
  edge [
    source 4
    target 9
    weight 9.5
    colour "blue"
  ]
  edge [
    source 5
    target 7
    weight 10.5
    colour "blue"
  ]
  edge [
    source 5
    target 8
    weight 11.5
    colour "blue"
  ]
  edge [
    source 6
    target 8
    weight 12.5
    colour "blue"
  ]
  edge [
    source 6
    target 9
    weight 13.5
    colour "blue"
  ]
  edge [
    source 7
    target 9
    weight 14.5
    colour "blue"
  ]
]
