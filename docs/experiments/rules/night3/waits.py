"""What must wait in the SUs, by walk: from the dump of records. kind r: records whose chunk is at or before bucket b and own bucket >= b"""
import numpy as np, sys
sys.path.insert(0,'/work/w/h4/docs/experiments/rules')
from rules import Scene
s=Scene(sys.argv[1])
print('buckets',s.nb)
r=s.rec
n=len(s.walks)
# straddle at the start of bucket b: chunk bucket < b... waits while watermark = b: chunk bucket<=b (sent) and own >= b
prof=s.prof['r']
# same bucket: chunk bucket = own bucket =b
same=np.zeros((n,s.nb)); m=r[:,1]==r[:,2]; np.add.at(same,(r[m,0],r[m,2]),r[m,3])
own=np.zeros((n,s.nb)); np.add.at(own,(r[:,0],r[:,2]),r[:,3])
ids=[i for i,w in enumerate(s.walks) if w[1]=='W']
top=sorted(ids,key=lambda i:-prof[i].max())[:int(sys.argv[2])]
for i in top:
    b=int(prof[i].argmax())
    print('window',s.walks[i][0],'count',s.count[i,0],'chunks',s.count[i,1],'gauss',s.count[i,2],'rec',s.count[i,4],'peak',int(prof[i].max()),'at',b,'own bucket',int(own[i,b]),'max own',int(own[i].max()),'buckets>5k',int((own[i]>5600).sum()),'straddle at b',int(prof[i,b]-own[i,b]), 'parts', [int(prof[s.at[(s.walks[i][0],'F',p)]].max()) if (s.walks[i][0],'F',p) in s.at else 0 for p in range(4)], 'H',[int(prof[s.at[(s.walks[i][0],'H',p)]].max()) if (s.walks[i][0],'H',p) in s.at else 0 for p in range(2)],'V',[int(prof[s.at[(s.walks[i][0],'V',p)]].max()) if (s.walks[i][0],'V',p) in s.at else 0 for p in range(2)])
